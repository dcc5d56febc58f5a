"""Pictures of robots: their trees of links and joints, and how they look from three sides."""
