"""From texts to files: what would be written (the plan), and writing it so that nothing is lost."""
