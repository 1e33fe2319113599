"""The parts of tests/mutants. Only Python's standard library is used."""
