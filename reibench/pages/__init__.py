"""Pages: widgets and wiring; what they show comes from `reibench.view`."""
