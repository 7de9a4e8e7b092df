"""One scene, one camera path and one list of figures, for any machine (README.md)."""
