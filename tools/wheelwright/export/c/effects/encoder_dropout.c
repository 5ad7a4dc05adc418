/* encoder_dropout: counts are missing or frozen for a while.
   Not said: it moves nothing; it is a property of recorded counts, which this simulation does not have. */
