"""The sentences of all rooms in the reader's language.

The rooms speak English and know no other language; their sentences keep the template and the values that they were made
of (`kitrobot.text.Sentence`). The doors translate them into the reader's language (`translator`). The languages are
gettext catalogues beside this file, one for each of `languages`, read on first use (`catalogue`); `tools/sentences.py`
finds sentences without a translation.
"""
