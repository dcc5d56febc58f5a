"""What the studio shows around the editor: panels, and the widgets and the data behind them."""
