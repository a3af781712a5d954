"""What the case pages show, as markup."""
