"""An eccentric cam against a flat tappet."""
