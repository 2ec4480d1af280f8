"""The script that made the files here needs packages that the tests do without."""

collect_ignore = ["files/make.py"]
