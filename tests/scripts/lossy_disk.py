"""A disk that loses what was not synced: replays the notes of noted_writes.cpp up to a power cut.

What was synced is kept; of the rest three models keep different things:

  strict  nothing: of a file its content at its last sync, of a folder its names at its last sync
  ext4    syncing a file also keeps all earlier changes of names, as its journal does. Of the later changes of names the first
          few are there, of the content of every file each unsynced page of 4096 bytes with a probability of one half
  torn    as ext4, but syncing a file keeps no name

A name of strict may be older than any real disk would have it; the pages of the others are there in no order.
"""
import dataclasses
import pathlib

MODELS = ("strict", "ext4", "torn")
PAGE = 4096


@dataclasses.dataclass(slots=True)
class Note:
    kind: str
    inode: int
    offset: int
    path: str
    other: str
    content: bytes


def read_notes(file):
    """All notes of a file, in their order."""
    text = pathlib.Path(file).read_bytes()
    notes, at = [], 0
    while at < len(text):
        end = text.index(b"\n", at)
        kind, inode, offset, count, path, other = text[at:end].decode().split("\t")
        begin, at = end + 1, end + 2 + int(count)
        notes.append(Note(kind, int(inode), int(offset), path, other, text[begin:at - 1]))
    return notes


class File:
    def __init__(self, content=b""):
        self.now = bytearray(content)
        self.kept = content
        self.pending = []  # (offset, bytes), and (size, None) where it was cut or extended

    def write(self, offset, content):
        put(self.now, offset, content)
        self.pending.append((offset, content))

    def resize(self, size):
        resize(self.now, size)
        self.pending.append((size, None))

    def sync(self):
        if self.pending:
            self.kept = bytes(self.now)
            self.pending = []

    def after_cut(self, model, random):
        if model == "strict" or not self.pending:
            return self.kept
        content = bytearray(self.kept)
        for offset, added in self.pending:
            if added is None:
                if random.random() < 0.5:
                    resize(content, offset)
                continue
            for begin in range(0, len(added), PAGE):
                if random.random() < 0.5:
                    put(content, offset + begin, added[begin:begin + PAGE])
        return bytes(content)


def resize(content, size):
    del content[size:]
    content.extend(bytes(size - len(content)))


def put(content, offset, added):
    if len(content) < offset:
        resize(content, offset)
    content[offset:offset + len(added)] = added


class Folder:
    def __init__(self):
        self.now = {}   # name → File or Folder
        self.kept = {}


def snapshot(folder):
    """All that is in a real folder: path below it → (inode, content, or None of a folder)."""
    folder = pathlib.Path(folder)
    return {str(path.relative_to(folder)): (path.stat().st_ino, None if path.is_dir() else path.read_bytes())
            for path in [folder, *sorted(folder.rglob("*"))]}


class Disk:
    """The files below a folder while notes are replayed. What a snapshot has is on the disk."""

    def __init__(self, root, model, files):
        self.root, self.model = root, model
        self.inodes = {}   # number → File or Folder
        self.changes = []  # of names, not synced: lists of (folder, name, node), where node is None if the name is removed
        self.version = 0   # grows with every sync: until then, strict keeps the same
        for path, (inode, content) in files.items():
            node = self.inodes[inode] = Folder() if content is None else File(content)
            if path == ".":
                self.top = node
            else:
                parent, name = self.place(f"{root}/{path}")
                parent.now[name] = parent.kept[name] = node

    def place(self, path):
        """The folder that has a path's last part, as it is now, and that part."""
        parts = path[len(self.root):].strip("/").split("/")
        folder = self.top
        for part in parts[:-1]:
            folder = folder.now[part]
        return folder, parts[-1]

    def take(self, note):
        if note.kind in ("file", "folder"):
            node = File() if note.kind == "file" else Folder()
            self.inodes[note.inode] = node
            folder, name = self.place(note.path)
            folder.now[name] = node
            self.changes.append([(folder, name, node)])
        elif note.kind == "remove":
            folder, name = self.place(note.path)
            del folder.now[name]
            self.changes.append([(folder, name, None)])
        elif note.kind == "move":
            folder, name = self.place(note.path)
            node = folder.now.pop(name)
            self.changes.append([(folder, name, None)])
            if note.other.startswith(self.root + "/"):
                new_folder, new_name = self.place(note.other)
                new_folder.now[new_name] = node
                self.changes[-1].append((new_folder, new_name, node))
        elif note.kind == "write":
            if note.inode in self.inodes:  # not of a file that was open and is gone
                self.inodes[note.inode].write(note.offset, note.content)
        elif note.kind == "size":
            self.inodes[note.inode].resize(note.offset)
        elif note.kind == "sync":
            self.sync(self.inodes.get(note.inode) if note.inode else None)

    def sync(self, node):
        self.version += 1
        if node is None:
            for each in self.inodes.values():
                if isinstance(each, File):
                    each.sync()
            self.keep(self.changes)
        elif isinstance(node, File):
            node.sync()
            if self.model == "ext4":
                self.keep(self.changes)
        else:
            self.keep(self.changes_of(node))

    def changes_of(self, folder):
        """The changes of a folder's names, with the earlier ones of the names that they move elsewhere."""
        chosen, places = [], set()
        for change in reversed(self.changes):
            own = {(id(where), name) for where, name, _ in change}
            if any(where is folder for where, _, _ in change) or own & places:
                chosen.insert(0, change)
                places |= own
        return chosen

    def keep(self, changes):
        for change in changes:
            apply(change, lambda folder: folder.kept)
        chosen = {id(change) for change in changes}
        self.changes = [change for change in self.changes if id(change) not in chosen]

    def after_cut(self, random):
        """path below the root → content, or None of a folder."""
        names = {}  # id of a folder → its names, where they differ from what is kept

        def names_of(folder):
            return names.setdefault(id(folder), dict(folder.kept))

        if self.model != "strict":
            for change in self.changes[:random.randint(0, len(self.changes))]:
                apply(change, names_of)
        found = {}

        def collect(folder, path):
            for name, node in names.get(id(folder), folder.kept).items():
                if isinstance(node, Folder):
                    found[path + name] = None
                    collect(node, path + name + "/")
                else:
                    found[path + name] = node.after_cut(self.model, random)

        collect(self.top, "")
        return found

    def now(self):
        """As `after_cut`, where nothing is lost."""
        found = {}

        def collect(folder, path):
            for name, node in folder.now.items():
                found[path + name] = None if isinstance(node, Folder) else bytes(node.now)
                if isinstance(node, Folder):
                    collect(node, path + name + "/")

        collect(self.top, "")
        return found


def apply(change, names_of):
    for folder, name, node in change:
        if node is None:
            names_of(folder).pop(name, None)
        else:
            names_of(folder)[name] = node


class Place:
    """A real folder that shows one state of a disk after the other."""

    def __init__(self, folder):
        self.folder = pathlib.Path(folder)
        self.shown = {}

    def show(self, files):
        for path in sorted(self.shown.keys() - files.keys(), reverse=True):
            target = self.folder / path
            if self.shown[path] is None:
                target.rmdir()
            else:
                target.unlink()
        for path in sorted(files):
            content = files[path]
            if path in self.shown and self.shown[path] is content:
                continue
            target = self.folder / path
            if content is None:
                target.mkdir(exist_ok=True)
            else:
                target.write_bytes(content)
        self.shown = files
