"""What commands take of the processor, however busy the machine."""
import resource


def processor_time():
    """Seconds of all children that have ended."""
    of_children = resource.getrusage(resource.RUSAGE_CHILDREN)
    return of_children.ru_utime + of_children.ru_stime
