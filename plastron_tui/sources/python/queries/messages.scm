; Where messages may be looked into.

(attribute) @attribute
