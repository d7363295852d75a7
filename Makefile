# Two front doors: `make figures` and `make test`. Each installs what is missing, configures, builds and runs.

JOBS ?= $(shell nproc)
PROFILE ?= quick
STUDIES ?= quick
# Continuous integration takes no warning.
WARNINGS = $(if $(CI),-DCMAKE_COMPILE_WARNING_AS_ERROR=ON)
SOURCES = git ls-files --cached --others --exclude-standard '*.cpp' '*.hpp'

.PHONY: help figures pdf article man deb test program build install format layout lint sanitize parts debug asan tsan

help:
	@echo "make figures  the report from committed results, then simulations, then charts of methods (PROFILE, STUDIES = quick or full)"
	@echo "make pdf      the report as build/report/report.pdf, after make figures"
	@echo "make man      manual page and shell completion, build/slfb.1 and build/slfb.bash"
	@echo "make deb      a Debian package, slfb_VERSION_ARCHITECTURE.deb in build; PRESET=portable for any x86-64 machine"
	@echo "make article  the reproduction as an article, build/article/article.pdf"
	@echo "make test     all tests"
	@echo "make program  build/slfb alone"
	@echo "make build    build/slfb and the tests"
	@echo "make install  the Debian packages that are missing (.ci/packages.txt)"
	@echo "make format   lay out the code"
	@echo "make layout   whether the code is laid out"
	@echo "make lint     layout and static checks (ROOMS)"
	@echo "make sanitize the fast tests with the address and undefined-behaviour sanitizers"
	@echo "make parts    a part of the builds debug and tsan: laws, threads of the solver"
	@echo "make debug    all tests without optimisation; asan, tsan: with the sanitizers"

figures: program
	build/slfb figures --profile $(PROFILE) --studies $(STUDIES) --open

pdf:
	@.ci/install print
	weasyprint --quiet build/report/print.html build/report/report.pdf

# PRESET and its folder of man and deb.
PRESET ?= release
BUILD = $(if $(filter release,$(PRESET)),build,build-$(PRESET))

man: install
	@.ci/install pack
	cmake --preset $(PRESET) $(WARNINGS)
	cmake --build --preset $(PRESET) --parallel $(JOBS) --target man

deb: man
	cd $(BUILD) && cpack -G DEB

article: program
	@.ci/install print
	build/slfb article --profile $(PROFILE)
	weasyprint --quiet build/article/article.html build/article/article.pdf

test: build
	ctest --preset release --parallel $(JOBS)

program: install
	cmake --preset release $(WARNINGS)
	cmake --build --preset release --parallel $(JOBS) --target slfb

build: install
	cmake --preset release $(WARNINGS)
	cmake --build --preset release --parallel $(JOBS)

install:
	@.ci/install build

# What is fast of the tests; `make asan` runs all of them. Under the sanitizer g++ warns of the standard library's own
# code, so warnings are no errors here.
sanitize: install
	cmake --preset asan
	cmake --build --preset asan --parallel $(JOBS) --target solver_tests threads_tests laws_tests
	ctest --preset asan --parallel $(JOBS) -R '^(solver|threads|laws)\.'

# A part of the other builds: the laws without optimisation, and the solver's threads with the thread sanitizer.
parts:
	@.ci/install build tools
	cmake --preset debug
	cmake --build --preset debug --parallel $(JOBS) --target laws_tests
	ctest --preset debug --parallel $(JOBS) -R '^laws\.'
	cmake --preset tsan
	cmake --build --preset tsan --parallel $(JOBS) --target threads_tests
	ctest --preset tsan -R '^threads\.'

debug asan tsan:
	@.ci/install build $(if $(filter tsan,$@),tools)
	cmake --preset $@
	cmake --build --preset $@ --parallel $(JOBS)
	ctest --preset $@ --parallel $(JOBS)

format:
	@.ci/install tools
	$(SOURCES) | xargs clang-format -i

layout:
	@.ci/install tools
	$(SOURCES) | xargs clang-format --dry-run --Werror

# ROOMS="solver/dem reports" checks a part.
ROOMS ?= correlations solver experiments reports tests
lint: layout build
	run-clang-tidy -quiet -p build -j $(JOBS) $(addsuffix /,$(addprefix $(CURDIR)/,$(ROOMS)))
