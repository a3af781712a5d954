"""The mark of the project."""

LOGO = (
    '<svg viewBox="0 0 32 32" aria-hidden="true"><rect width="32" height="32" rx="8"'
    ' fill="var(--accent)"/><path d="M9 11h14M9 16h9M9 21h5" stroke="var(--accent-ink)"'
    ' stroke-width="2.600" stroke-linecap="round"/><circle cx="22" cy="20" r="4" fill="none"'
    ' stroke="var(--accent-ink)" stroke-width="2.400"/></svg>'
)
