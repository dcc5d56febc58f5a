; In comments, what a grammar for comments knows: a TODO, an address.

([(line_comment) (block_comment)] @injection.content
  (#set! injection.language "comment"))
