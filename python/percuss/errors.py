"""What readers raise."""


class NotResults(Exception):
    """A file or folder is missing, damaged or of another program; str() is a message for the user."""
