"""Scene files, a table a call."""
import json


def table(header, **keys):
    """A header and its keys; without a header those of the top."""
    lines = [f"{key} = {json.dumps(value)}" for key, value in keys.items()]
    return "".join(f"{line}\n" for line in ([header] if header else []) + lines)


def finger(name, shape, **keys):
    return table("[[finger]]", name=name, shape=shape, **keys)


def pusher(name, shape, **keys):
    return table("[[pusher]]", name=name, shape=shape, **keys)


def without(text, *names):
    """A scene's text without these pushers."""
    for name in names:
        begin = text.index(f'[[pusher]]\nname = "{name}"')
        end = text.find("[[pusher]]", begin + 5)
        text = text[:begin] + (text[end:] if end > 0 else "")
    return text
