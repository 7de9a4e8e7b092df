"""The parts of SConstruct: compilers and flags, the engine's API and the binding, generated sources."""
