"""The outside world: hearing, speaking, ports, storage, the loop, the command line. All waiting happens here."""
