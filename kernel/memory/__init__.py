"""Attention, working memory, halo, rules, operators, choice, and what an utterance can mean."""
