"""What is shipped: reading libraries of all systems, what must hold of them, and the zip."""
