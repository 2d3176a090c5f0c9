"""The way in from outside: control socket and command line."""
