"""The private toolchain in .toolchain/: what a fresh machine lacks, fetched without touching the system."""
