"""What nobody writes in a robot's XML because every robot has it: the methods of variables, `Fault`, a team's work.

Values given by Set, Add and Sub are clamped to the variable's range by the compiler. The range of what is *added* is
the width of the variable's range, both ways.
"""

from __future__ import annotations

from kitrobot.primitives.robot import (
    LARGEST_VALUE,
    Category,
    Kind,
    Method,
    Parameter,
    RobotObject,
    SearchWords,
    Texts,
    ValueType,
)

FAULT = "Fault"
"""The system object that says whether a number had to be clamped."""

TAKE, DONE = "Take", "Done"
"""The procedures of a team's work: a unit is this robot's, and is done."""


def texts(english: str, french: str, urdu: str) -> Texts:
    """A text in the three languages."""
    return {"": english, "fr": french, "ur": urdu}


def _label(french: str, urdu: str, english: str = "") -> Texts:
    """What stands for a name that is English, and in plain English where the name is not."""
    return {"": english, "fr": french, "ur": urdu} if english else {"fr": french, "ur": urdu}


def _words(english: str, french: str, urdu: str) -> SearchWords:
    """The words that find a part in the palette, as `<word>` holds them."""
    return {"": tuple(english.split(", ")), "fr": tuple(french.split(", ")), "ur": tuple(urdu.split("، "))}


def comparison(test: str, right: str) -> Texts:
    """The phrase of a chip for a test against a number or a parameter (`{value}`)."""
    return {"": f"{{object}} {_SIGNS[test]} {right}"}


_SIGNS = {"equal": "=", "less": "<", "greater": ">"}
_TESTS = (
    (
        "EqualTo",
        "equal",
        "equal",
        _label("Égal à", "برابر", "Equal to"),
        texts("Is it exactly this number?", "Est-ce exactement ce nombre ?", "کیا یہ بالکل یہی عدد ہے؟"),
        _words("same, is, equals", "même, pareil, est", "ایک جیسا، وہی"),
    ),
    (
        "LessThan",
        "less",
        "chevron-left",
        _label("Plus petit que", "سے کم", "Less than"),
        texts("Is it smaller than this number?", "Est-ce plus petit que ce nombre ?", "کیا یہ اس عدد سے چھوٹا ہے؟"),
        _words("smaller, fewer, under", "moins, inférieur", "چھوٹا، نیچے"),
    ),
    (
        "GreaterThan",
        "greater",
        "chevron-right",
        _label("Plus grand que", "سے زیادہ", "Greater than"),
        texts("Is it bigger than this number?", "Est-ce plus grand que ce nombre ?", "کیا یہ اس عدد سے بڑا ہے؟"),
        _words("bigger, more, over", "plus, supérieur", "بڑا، اوپر"),
    ),
)
_VALUE_LABEL = _label("valeur", "قدر")
_VALUE_HELP = texts("The number to use.", "Le nombre à utiliser.", "استعمال ہونے والا عدد۔")
_TRUTH_HELP = texts("0 is false, 1 is true.", "0 veut dire faux, 1 veut dire vrai.", "0 کا مطلب غلط، 1 کا مطلب درست۔")


def _change(
    name: str, parameter: Parameter, icon: str, label: Texts, help: Texts, phrase: str, words: SearchWords
) -> Method:
    """A procedure of a variable that changes it; its action has its name."""
    return Method(
        name,
        Kind.PROCEDURE,
        (parameter,),
        action=name.lower(),
        icon=icon,
        label=label,
        help=help,
        phrase={"": phrase},
        words=words,
    )


def _set_method(value: Parameter, help: Texts) -> Method:
    words = _words("put, make, change, becomes", "changer, donner, devient", "بدلنا، بنانا، ہو جائے")
    return _change("Set", value, "pencil", _label("Mettre", "رکھو"), help, "{object} := {value}", words)


_VALUE = Method(
    "Value",
    Kind.VALUE,
    icon="hash",
    label=_label("Valeur", "قدر"),
    help=texts(
        "The number that the variable holds now.", "Le nombre que contient la variable.", "متغیر میں موجود عدد۔"
    ),
    phrase={"": "{object}"},
    words=_words("number, read", "nombre, lire", "عدد، پڑھنا"),
)


def integer_methods(minimum: int, maximum: int, initial: int) -> tuple[Method, ...]:
    """Set, Add, Sub, Value, EqualTo, LessThan, GreaterThan of a variable that holds a number."""
    span = min(maximum - minimum, LARGEST_VALUE)
    value = Parameter("value", minimum, maximum, initial, label=_VALUE_LABEL, help=_VALUE_HELP)
    amount = Parameter("value", -span, span, min(1, span), label=_VALUE_LABEL, help=_VALUE_HELP)
    return (
        _set_method(
            value,
            texts(
                "Gives the variable a new number.",
                "Donne un nouveau nombre à la variable.",
                "متغیر کو نیا عدد دیتا ہے۔",
            ),
        ),
        _change(
            "Add",
            amount,
            "plus",
            _label("Ajouter", "جمع کرو"),
            texts(
                "Makes the variable bigger by a number.",
                "Ajoute un nombre à la variable.",
                "متغیر میں ایک عدد جمع کرتا ہے۔",
            ),
            "{object} + {value}",
            _words("plus, more, count, increase, bigger", "plus, compter, augmenter", "زیادہ، گننا، بڑھانا"),
        ),
        _change(
            "Sub",
            amount,
            "minus",
            _label("Enlever", "گھٹاؤ", "Subtract"),
            texts(
                "Makes the variable smaller by a number.",
                "Enlève un nombre à la variable.",
                "متغیر میں سے ایک عدد گھٹاتا ہے۔",
            ),
            "{object} − {value}",
            _words("minus, less, fewer, take away, decrease", "moins, retirer, diminuer", "منفی، کم، نکالنا"),
        ),
        _VALUE,
        *(
            Method(
                name,
                Kind.TEST,
                (value,),
                test=test,
                icon=icon,
                label=label,
                help=help,
                phrase=comparison(test, "{value}"),
                words=words,
            )
            for name, test, icon, label, help, words in _TESTS
        ),
    )


def number_variable(name: str, most: int) -> RobotObject:
    """A variable of no file that holds a number from 0 to `most`."""
    return RobotObject(name, Category.VARIABLE, integer_methods(0, most, 0), maximum=most)


def boolean_methods(initial: int) -> tuple[Method, ...]:
    """Set, IsTrue, IsFalse of a variable that holds true or false."""
    value = Parameter("value", 0, 1, initial, type=ValueType.BOOLEAN, label=_VALUE_LABEL, help=_TRUTH_HELP)
    return (
        _set_method(
            value,
            texts(
                "Makes the variable true or false.",
                "Rend la variable vraie ou fausse.",
                "متغیر کو درست یا غلط بناتا ہے۔",
            ),
        ),
        Method(
            "IsTrue",
            Kind.TEST,
            test="equal",
            to=1,
            icon="toggle-right",
            label=_label("Est vrai", "درست ہے", "Is true"),
            help=texts("Is the variable true?", "La variable est-elle vraie ?", "کیا متغیر درست ہے؟"),
            phrase=texts("{object} is true", "{object} est vrai", "{object} درست ہے"),
            words=_words("yes, on", "oui, vrai", "ہاں، سچ"),
        ),
        Method(
            "IsFalse",
            Kind.TEST,
            test="equal",
            to=0,
            icon="toggle-left",
            label=_label("Est faux", "غلط ہے", "Is false"),
            help=texts("Is the variable false?", "La variable est-elle fausse ?", "کیا متغیر غلط ہے؟"),
            phrase=texts("{object} is false", "{object} est faux", "{object} غلط ہے"),
            words=_words("no, off", "non, faux", "نہ، جھوٹ"),
        ),
    )


def fault_object() -> RobotObject:
    """`Fault`: raised when a number was out of range and had to be clamped."""
    return RobotObject(
        FAULT,
        Category.SYSTEM,
        (
            Method(
                "IsRaised",
                Kind.TEST,
                test="equal",
                to=1,
                icon="triangle-alert",
                label=_label("Est levé", "اٹھا ہوا ہے", "Is raised"),
                help=texts(
                    "Did a number go out of its range since the last Clear?",
                    "Un nombre est-il sorti de ses limites depuis le dernier Effacer ?",
                    "کیا پچھلے «مٹاؤ» کے بعد کوئی عدد اپنی حد سے باہر گیا؟",
                ),
                phrase=texts("{object} is raised", "{object} est levé", "{object} اٹھا ہوا ہے"),
            ),
            Method(
                "Clear",
                Kind.PROCEDURE,
                action="clear",
                icon="eraser",
                label=_label("Effacer", "مٹاؤ"),
                help=texts("Forgets the fault.", "Oublie le défaut.", "خرابی بھلا دیتا ہے۔"),
            ),
        ),
        type=ValueType.BOOLEAN,
        maximum=1,
        icon="triangle-alert",
        label=_label("Défaut", "خرابی"),
        help=texts(
            "Goes up when a number had to be cut to fit its range, for example a speed of 120.",
            "Se lève quand un nombre a dû être ramené dans ses limites, par exemple une vitesse de 120.",
            "جب کسی عدد کو اس کی حد میں لانا پڑے، مثلاً رفتار 120، تو یہ اٹھ جاتا ہے۔",
        ),
    )


_WORK_METHODS = (
    Method(
        TAKE,
        Kind.PROCEDURE,
        completes_later=True,
        icon="hand",
        label=_label("Prendre", "لو"),
        help=texts(
            "Waits until a unit is this robot's, or until none is left.",
            "Attend qu'une unité soit à ce robot, ou qu'il n'en reste plus.",
            "انتظار کرتا ہے کہ ایک اکائی اس روبوٹ کو ملے، یا کوئی باقی نہ رہے۔",
        ),
    ),
    Method(
        DONE,
        Kind.PROCEDURE,
        completes_later=True,
        icon="check",
        label=_label("Fini", "ہو گیا"),
        help=texts(
            "Says that the unit that this robot took is done.",
            "Dit que l'unité prise par ce robot est finie.",
            "بتاتا ہے کہ اس روبوٹ کی لی ہوئی اکائی مکمل ہو گئی۔",
        ),
    ),
    Method(
        "IsEmpty",
        Kind.TEST,
        test="equal",
        to=0,
        icon="package-open",
        label=_label("Est vide", "خالی ہے", "Is empty"),
        help=texts("Are all units done?", "Toutes les unités sont-elles finies ?", "کیا سب اکائیاں مکمل ہو گئیں؟"),
        phrase=texts("{object} is empty", "{object} est vide", "{object} خالی ہے"),
    ),
    Method(
        "Left",
        Kind.VALUE,
        icon="hash",
        label=_label("Reste", "باقی"),
        help=texts(
            "How many units are not done yet.",
            "Combien d'unités ne sont pas encore finies.",
            "کتنی اکائیاں ابھی مکمل نہیں ہوئیں۔",
        ),
        phrase=texts("what is left of {object}", "reste de {object}", "{object} میں سے باقی"),
    ),
)


def work_object(name: str, units: int) -> RobotObject:
    """A work of the team: units that its members share out among themselves."""
    return RobotObject(
        name,
        Category.SYSTEM,
        _WORK_METHODS,
        maximum=units,
        initial=units,
        shared=True,
        icon="package",
        help=texts(
            "A work of the team: units that its robots share out among themselves.",
            "Un travail de l'équipe : des unités que ses robots se partagent.",
            "ٹیم کا کام: اکائیاں جو اس کے روبوٹ آپس میں بانٹ لیتے ہیں۔",
        ),
    )
