"""The forklift robot of the paper: its wire, its physics."""
