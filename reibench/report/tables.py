"""Every LaTeX table, by its name on the command line."""

from collections.abc import Callable

import pandas as pd

from reibench.dialogue import CONTEXTS
from reibench.report.error_tables import errors_by_method, errors_by_model
from reibench.report.summary_tables import success_table, token_table

TABLES: dict[str, Callable[[pd.DataFrame], str]] = {
    "errors-by-model": errors_by_model,
    "errors-by-method": errors_by_method,
    "errors-by-model-all-contexts": lambda frame: errors_by_model(frame, CONTEXTS),
    "errors-by-method-all-contexts": lambda frame: errors_by_method(frame, CONTEXTS),
    "tokens": token_table,
    "success": success_table,
}
