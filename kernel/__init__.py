"""The mind: semantic net, memory, chains, directives, grounding, bodies. Same inputs, same outputs, always."""
