"""Voices: how the robot is heard."""
