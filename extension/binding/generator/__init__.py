"""The generator of the binding, one module per kind of output."""
