"""A checker for each definition, lemma and theorem: it reads records and returns findings."""
