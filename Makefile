# `make demo` and `make test` do all their set-up in .venv; they need Python >= 3.11 and a package index.

PYTHON ?= python3
JOBS ?= 2
VENV := .venv
BIN := $(VENV)/bin
STAMP := $(VENV)/.installed
OUT := out
NAME := south_africa
POLYGON := examples/ne_south_africa_50m.json

.PHONY: demo test test-long lint types pytest clean
.DELETE_ON_ERROR:

demo: $(STAMP)
	@mkdir -p $(OUT)
	@echo "South Africa, with Lesotho as its hole. Theorem 1, every claim checked after its stage:"
	$(BIN)/bern-exact triangulate $(POLYGON) --theorem 1 -o $(OUT)/$(NAME).mesh.json --svg $(OUT)/$(NAME).svg
	@echo
	@echo "The judge: one file, standard library only, imports nothing of the package:"
	$(BIN)/python -I bern_exact/oracle/judge.py $(OUT)/$(NAME).mesh.json $(POLYGON)
	@echo
	@echo "The same by Theorem 3, no angle above 150 degrees, and thinned; and the judge on that:"
	$(BIN)/bern-exact triangulate $(POLYGON) --theorem 3 --thin -o $(OUT)/thin.mesh.json --svg $(OUT)/thin.svg
	$(BIN)/python -I bern_exact/oracle/judge.py $(OUT)/thin.mesh.json --max-angle 150
	@echo
	@echo "Look at $(OUT)/$(NAME).svg and $(OUT)/thin.svg in a browser, and at the certificates at the end of the .mesh.json files"

test: lint types pytest

lint: $(STAMP)
	$(BIN)/ruff check .
	$(BIN)/ruff format --check .

types: $(STAMP)
	$(BIN)/mypy --strict -p bern_exact -p proofs

pytest: $(STAMP)
	$(BIN)/python -m pytest -n $(JOBS)

# The largest real polygons through every theorem: minutes beside the suite.
test-long: $(STAMP)
	$(BIN)/python -m pytest -n $(JOBS) -m long

# Made again whenever the list of dependencies may have changed.
$(STAMP): pyproject.toml
	@$(PYTHON) -c 'import sys; sys.exit(sys.version_info < (3, 11))' || \
	  { echo "Python 3.11 or newer is needed: make PYTHON=/path/to/python3.11 ..." >&2; exit 1; }
	@test -x $(BIN)/python || $(PYTHON) -m venv $(VENV)
	$(BIN)/python -m pip install --quiet --disable-pip-version-check --editable '.[dev]'
	@touch $@

clean:
	rm -rf $(VENV) out build dist *.egg-info .mypy_cache .pytest_cache .ruff_cache .hypothesis
