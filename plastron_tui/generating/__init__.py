"""From what a program asks for to file texts, with what stands in the files already."""
