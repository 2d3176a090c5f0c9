"""From sound to words: sources, engines behind one protocol, and the listener between them."""
