"""The wire: protocol fk/1 as bytes and messages, without port or clock."""
