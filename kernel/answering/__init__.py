"""One file for each kind of question about the robot itself; each registers its code with @answers(TOPIC, ...)."""
