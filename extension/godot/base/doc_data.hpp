#pragma once

/// The class reference of doc_classes/. The build writes it as one array.
extern const char undergrowth_doc_xml[];
extern const unsigned long undergrowth_doc_xml_size;
