#pragma once

/// The class help of doc_classes/, made into one array by the build.
extern const char undergrowth_doc_xml[];
extern const unsigned long undergrowth_doc_xml_size;
