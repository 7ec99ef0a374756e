# SPDX-License-Identifier: BSD-3-Clause
"""Settings of Sphinx, which scripts/docs runs on the folder that stage.py makes."""

import os
import sys

from pygments.lexers.rust import RustLexer
from sphinx.util import logging

project = "libstltsa"
author = "libstltsa"
html_title = "libstltsa"
extensions = ["myst_parser", "breathe", "sphinx.ext.autodoc", "numpydoc"]
exclude_patterns = ["README.md", "doxygen", "python"]  # index.md includes the README
highlight_language = "none"  # most blocks without a language are commands and formulas
smartquotes = False
nitpicky = True

myst_heading_anchors = 3

breathe_projects = {"stltsa": os.environ["STLTSA_DOXYGEN"]}
breathe_default_project = "stltsa"
breathe_domain_by_extension = {"h": "c"}
breathe_show_enumvalue_initializer = True
# Types of the C library and the preprocessor have no page.
nitpick_ignore = [("c:identifier", name) for name in
                  ("int32_t", "int64_t", "size_t")]

package, installed = os.environ["STLTSA_PYTHON"].split(":")
sys.path.insert(0, package)
sys.path.append(installed)
autodoc_typehints = "none"
autodoc_member_order = "bysource"
autodoc_default_options = {"members": True}
numpydoc_show_class_members = False

html_theme = "furo"
html_static_path = ["site.css"]
html_css_files = ["site.css"]
html_copy_source = False
html_show_sourcelink = False
html_show_sphinx = False
html_show_copyright = False


def skip_fields(app, what, name, member, skip, options):
    """Leave out Python's own text for the fields of a named tuple, which its docstring describes."""
    text = str(getattr(member, "__doc__", ""))
    return True if text.startswith("Alias for field number") else None


def hide_handle(app, what, name, thing, options, signature, returns):
    """Leave out the signature of constructors that only the package itself calls."""
    return ("", returns) if signature and signature.startswith("(handle") else None


def check_python(app, env):
    """Check that the Python reference has every public name of the package."""
    import stltsa  # from the path above
    have = env.get_domain("py").objects
    for name in set(stltsa.__all__) - {"__version__"}:
        if f"stltsa.{name}" not in have and f"stltsa.errors.{name}" not in have:
            logging.getLogger(__name__).warning("docs/site/python.rst lacks %s", name)


def setup(app):
    app.connect("env-check-consistency", check_python)
    app.connect("autodoc-process-signature", hide_handle)
    app.add_lexer("rust,no_run", RustLexer)  # rustdoc's mark for a program that is not run
    app.connect("autodoc-skip-member", skip_fields)
