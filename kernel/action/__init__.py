"""What acting is made of: verdicts, chains and plays, calls and bids, arbitration, the trace."""
