"""How each kind of test suite is run and its output read."""
