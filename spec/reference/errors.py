"""The errors of chapter 14."""


class Invalid(Exception):
    """A file that the specification calls invalid; `error` is a name of chapter 14."""

    def __init__(self, error, why):
        super().__init__(f"{error}: {why}")
        self.error = error
        self.why = why


def corrupt(why):
    return Invalid("corrupt", why)


def require(condition, why):
    """`corrupt` unless the condition holds."""
    if not condition:
        raise corrupt(why)
