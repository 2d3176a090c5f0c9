"""English in, English out: text to meanings, nets to sentences. Pure."""
