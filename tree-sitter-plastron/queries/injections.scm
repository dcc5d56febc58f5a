; In comments, what a grammar for comments knows: notes, addresses.

([(line_comment) (block_comment)] @injection.content
  (#set! injection.language "comment"))
