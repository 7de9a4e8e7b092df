"""Counts the instructions of the core's kernels on processors that this machine does not have."""
