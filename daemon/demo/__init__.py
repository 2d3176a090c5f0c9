"""The paper's demonstration: script, recordings, and telling it live."""
