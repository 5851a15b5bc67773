"""What readers raise."""


class NotResults(Exception):
    """A file or folder is missing, damaged or of another program; str() is a message for the user."""


class NoFrames(NotResults):
    """A file of fields has no frame yet."""
