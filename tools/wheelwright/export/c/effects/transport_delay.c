/* transport_delay: more delay than the linear model holds.
   Inverse: nothing to undo at a steady speed; no command acts before it was sent. */
enum { transport_delay_room = 512 };

typedef struct {
  ww_pair past[transport_delay_room];
  int at;
} transport_delay_state;

static inline void transport_delay_reset(transport_delay_state* s, const double* p, int variant) {
  int i;
  (void)p;
  (void)variant;
  for (i = 0; i < transport_delay_room; ++i) s->past[i].left = s->past[i].right = 0.0;
  s->at = 0;
}

static inline void transport_delay_wheels(transport_delay_state* s, const double* p, int variant,
                                          const ww_around* around, ww_pair* command) {
  const double periods = fmin(p[0] / around->period_s, transport_delay_room - 2);
  const int whole = (int)periods;
  const double share = periods - whole;
  ww_pair newer, older;
  (void)variant;
  s->past[s->at] = *command;
  newer = s->past[(s->at + transport_delay_room - whole) % transport_delay_room];
  older = s->past[(s->at + transport_delay_room - whole - 1) % transport_delay_room];
  command->left = newer.left + share * (older.left - newer.left);
  command->right = newer.right + share * (older.right - newer.right);
  s->at = (s->at + 1) % transport_delay_room;
}
