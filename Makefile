# `make app` and `make test` are all one needs; each does first what it depends on.
PYTHON ?= python3
VENV ?= .venv
BIN = $(VENV)/bin

.PHONY: app test setup lint types screenshots

app: $(VENV)/.runtime
	$(BIN)/python app.py $(ARGS)

setup: $(VENV)/.runtime

test: $(VENV)/.tests lint types
	$(BIN)/pytest -n 2 --dist loadfile

lint: $(VENV)/.tests
	$(BIN)/ruff format --check .
	$(BIN)/ruff check .

types: $(VENV)/.tests
	$(BIN)/mypy

screenshots: $(VENV)/.tests
	$(BIN)/python -m tests.browser.screenshots

$(VENV)/bin/python:
	@$(PYTHON) -c 'import sys; sys.exit(sys.version_info < (3, 11) and "Python 3.11 or newer is needed, but $(PYTHON) is %d.%d; name another with PYTHON=." % sys.version_info[:2])'
	$(PYTHON) -m venv $(VENV)

$(VENV)/.runtime: requirements.txt | $(VENV)/bin/python
	$(BIN)/pip install --disable-pip-version-check -r requirements.txt
	@touch $@

$(VENV)/.tests: requirements.txt requirements-hf.txt requirements-ray.txt requirements-train.txt requirements-study.txt tests/requirements.txt | $(VENV)/bin/python
	$(BIN)/pip install --disable-pip-version-check -r tests/requirements.txt
	@touch $@ $(VENV)/.runtime
