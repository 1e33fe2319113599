"""The parts of fuzz/campaign. Only Python's standard library is used."""
