"""What all pages tell Gradio: how events travel, and what of its own is switched off."""

from typing import Any

QUICK: dict[str, Any] = {
    "queue": False,
    "show_progress": "hidden",
    "api_visibility": "private",
    "trigger_mode": "multiple",
}
"""Of an event that is answered at once; every click counts, and its handler authorises."""
MOUNTED: dict[str, Any] = {"footer_links": [], "run_history": False, "enable_monitoring": False}
"""Nothing a visitor does is kept by Gradio, nor shown to others."""
