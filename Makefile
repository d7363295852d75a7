# Two front doors: `make figures` and `make test`. Each installs what is missing, configures, builds and runs.

JOBS ?= $(shell nproc)
PROFILE ?= quick
STUDIES ?= quick
SOURCES = git ls-files --cached --others --exclude-standard '*.cpp' '*.hpp'

.PHONY: help figures pdf test program build install format lint sanitize debug asan tsan

help:
	@echo "make figures  the figures of the paper and the report (PROFILE, STUDIES = quick or full)"
	@echo "make pdf      the report as build/report/report.pdf, after make figures"
	@echo "make test     all tests"
	@echo "make program  build/slfb alone"
	@echo "make build    build/slfb and the tests"
	@echo "make install  the Debian packages that are missing (.ci/packages.txt)"
	@echo "make format   lay out the code"
	@echo "make lint     layout and static checks"
	@echo "make sanitize the fast tests with the address and undefined-behaviour sanitizers"
	@echo "make debug    all tests without optimisation; asan, tsan: with the sanitizers"

figures: program
	build/slfb frontier --set $(STUDIES)
	build/slfb stability --set $(STUDIES)
	build/slfb figures --profile $(PROFILE)
	@if [ -z "$$CI" ] && [ -n "$$DISPLAY$$WAYLAND_DISPLAY" ] && command -v xdg-open >/dev/null; then \
	  xdg-open build/report/index.html >/dev/null 2>&1 || true; \
	fi

pdf:
	@.ci/install print
	weasyprint --quiet build/report/print.html build/report/report.pdf

test: build
	ctest --preset release --parallel $(JOBS)

program: install
	cmake --preset release
	cmake --build --preset release --parallel $(JOBS) --target slfb

build: install
	cmake --preset release
	cmake --build --preset release --parallel $(JOBS)

install:
	@.ci/install build

debug asan tsan:
	@.ci/install build $(if $(filter tsan,$@),tools)
	cmake --preset $@
	cmake --build --preset $@ --parallel $(JOBS)
	ctest --preset $@ --parallel $(JOBS)

format:
	@.ci/install tools
	$(SOURCES) | xargs clang-format -i

lint: build
	@.ci/install tools
	$(SOURCES) | xargs clang-format --dry-run --Werror
	run-clang-tidy -quiet -p build -j $(JOBS) '$(CURDIR)/(correlations|solver|experiments|reports|tests)/'
