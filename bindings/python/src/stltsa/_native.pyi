# The extension that cffi makes from stltsa.h; what is in it is described there.
from typing import Any

ffi: Any
lib: Any
